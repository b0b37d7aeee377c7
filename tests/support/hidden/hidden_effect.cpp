#include "support/hidden/hidden_effect.hpp"

#include <stdexcept>

namespace braidzone::hidden {

std::string_view name_of(EffectSize size)
{
    switch (size) {
        case EffectSize::weak:
            return "weak";
        case EffectSize::medium:
            return "medium";
        case EffectSize::strong:
            return "strong";
    }
    return {};
}

const std::vector<EffectMaker>& effect_makers()
{
    static const std::vector<EffectMaker> all = [] {
        std::vector<EffectMaker> makers;
        for (const auto& some : {release_effects(), device_effects(), vessel_effects(),
                                 scan_effects(), unknown_effects()})
            makers.insert(makers.end(), some.begin(), some.end());
        return makers;
    }();
    return all;
}

void hide(std::string_view name, EffectSize size, HiddenStory& story, std::mt19937& random)
{
    for (const EffectMaker& maker : effect_makers()) {
        if (maker.name != name) continue;
        story.effects.push_back({std::string(name), size, maker.hide(story, size, random)});
        return;
    }
    throw std::invalid_argument("no effect " + std::string(name));
}

double between(double low, double high, std::mt19937& random)
{
    return std::uniform_real_distribution<double>(low, high)(random);
}

double sized(EffectSize size, const SizeBounds& bounds, std::mt19937& random)
{
    const auto i = static_cast<std::size_t>(size);
    return between(bounds[i], bounds[i + 1], random);
}

double either_sign(double value, std::mt19937& random)
{
    return between(-1.0, 1.0, random) < 0.0 ? -value : value;
}

double along_device(const Belief& belief, std::mt19937& random)
{
    return between(belief.landing - 14e-3, belief.landing - 6e-3, random);
}

double neck_of(const Belief& belief)
{
    return belief.phantom.sacs.front().position.value();
}

}  // namespace braidzone::hidden
