#pragma once

#include "core/quantity.hpp"

#include <optional>
#include <string>
#include <vector>

namespace braidzone {

/// Collects the keys whose values differ between two files, "section.key=value": overrides that
/// make one out of the other.
class ChangedKeys {
public:
    /// @param dimension  of the value [SI]; none: a plain number
    void add(const std::string& key, double before, double after,
             std::optional<Dimension> dimension = {});

    const std::vector<std::string>& overrides() const { return overrides_; }

private:
    std::vector<std::string> overrides_;
};

}  // namespace braidzone
