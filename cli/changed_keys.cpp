#include "cli/changed_keys.hpp"

#include <fmt/format.h>

namespace braidzone {

void ChangedKeys::add(const std::string& key, double before, double after,
                      std::optional<Dimension> dimension)
{
    if (after == before) return;
    overrides_.push_back(dimension
                             ? fmt::format("{}=\"{}\"", key, format_quantity(after, *dimension))
                             : fmt::format("{}={}", key, after));
}

}  // namespace braidzone
