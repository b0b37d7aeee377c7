#pragma once

#include "core/vector.hpp"

#include <cstddef>
#include <vector>

namespace braidzone {

/// The braid on its way to rest.
struct Frame {
    int step = 0;             ///< steps since the first release
    int num_released = 0;     ///< rings that had left the catheter
    std::vector<Vec3> nodes;  ///< |N| x 3 [m]
};

/// Largest force on a free node after a number of steps [N].
struct ResidualSample {
    int step = 0;
    double residual = 0.0;
};

/// Keeps shapes at equal numbers of steps of a motion whose end is not known beforehand: it takes
/// one every so many steps, and whenever it holds eight times as many as are wanted, drops every
/// other one and takes half as many from then on.
///
/// The shape is anything that can be copied; `Shape` is the distance of each node to its hub for
/// rings that are locked in their planes.
template <typename Shape>
class MotionRecord {
public:
    struct Entry {
        int step = 0;
        int num_released = 0;
        Shape shape;
    };

    /// @param num_wanted  frames to keep; 0 keeps none
    explicit MotionRecord(int num_wanted) : num_wanted_(num_wanted) {}

    /// True at the steps of which a shape is taken.
    bool wants(int step) const { return num_wanted_ > 0 && step % stride_ == 0; }

    void add(int step, int num_released, const Shape& shape)
    {
        entries_.push_back({step, num_released, shape});
        if (entries_.size() < 8 * static_cast<std::size_t>(num_wanted_)) return;
        std::size_t kept = 1;
        for (std::size_t i = 2; i < entries_.size(); i += 2)
            entries_[kept++] = std::move(entries_[i]);
        entries_.resize(kept);
        stride_ *= 2;
    }

    /// The wanted number of shapes nearest to equal distances between the first and the last step,
    /// or all that there are if there are fewer; the given last one ends them.
    std::vector<Entry> finish(int last_step, int num_released, const Shape& last)
    {
        if (num_wanted_ == 0) return {};
        std::vector<Entry> chosen;
        std::size_t next = 0;
        for (int i = 0; i + 1 < num_wanted_; ++i) {
            const double wanted = static_cast<double>(last_step) * i / (num_wanted_ - 1);
            while (next < entries_.size() && entries_[next].step < wanted - 0.5 * stride_)
                ++next;
            if (next == entries_.size() || entries_[next].step >= last_step) break;
            chosen.push_back(entries_[next++]);
        }
        chosen.push_back({last_step, num_released, last});
        return chosen;
    }

private:
    int num_wanted_ = 0;
    int stride_ = 1;
    std::vector<Entry> entries_;
};

}  // namespace braidzone
