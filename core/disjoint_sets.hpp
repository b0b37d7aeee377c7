#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace braidzone {

/// Sets that are merged step by step (union by smaller index, path halving).
class DisjointSets {
public:
    explicit DisjointSets(std::size_t size) : parent_(size)
    {
        std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    }
    std::size_t find(std::size_t element)
    {
        while (parent_[element] != element) {
            parent_[element] = parent_[parent_[element]];
            element = parent_[element];
        }
        return element;
    }
    void unite(std::size_t a, std::size_t b)
    {
        a = find(a);
        b = find(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::size_t> parent_;
};

}  // namespace braidzone
