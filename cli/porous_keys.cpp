#include "cli/porous_keys.hpp"

#include "cli/key_checks.hpp"

namespace braidzone {
namespace {

ConstantLaw read_constant_law(const TomlTable& table)
{
    ConstantLaw law;
    law.loss.linear =
        require_not_negative(table, "pressure_loss_linear",
                             table.quantity("pressure_loss_linear", Dimension::linear_loss));
    law.loss.quadratic = require_not_negative(
        table, "pressure_loss_quadratic",
        table.quantity_or("pressure_loss_quadratic", Dimension::quadratic_loss, 0.0));
    return law;
}

MeasuredLaw read_measured_keys(const TomlTable& table)
{
    const std::filesystem::path file = file_path(table, "loss_table");
    Fluid bench;
    bench.density = require_positive(table, "bench_density",
                                     table.quantity("bench_density", Dimension::density));
    bench.viscosity = require_positive(
        table, "bench_viscosity", table.quantity("bench_viscosity", Dimension::dynamic_viscosity));
    return read_measured_law(file, bench);
}

/// A law whose correlation is fitted up to a velocity.
template <typename Law>
Law read_fitted_law(const TomlTable& table)
{
    return {.fit_velocity =
                positive_or(table, "fit_velocity", Dimension::velocity, Law{}.fit_velocity)};
}

}  // namespace

Fluid read_fluid(const TomlTable& table)
{
    Fluid fluid;
    fluid.density = positive_or(table, "density", Dimension::density, fluid.density);
    fluid.viscosity =
        positive_or(table, "viscosity", Dimension::dynamic_viscosity, fluid.viscosity);
    return fluid;
}

ResistanceLaw read_law(const TomlTable& table)
{
    const std::string name = one_of(table, "law", BraidStokesLaw::name, law_names());
    if (name == BrundrettLaw::name) return read_fitted_law<BrundrettLaw>(table);
    if (name == GedeonWoodLaw::name) return read_fitted_law<GedeonWoodLaw>(table);
    if (name == ErgunLaw::name) return ErgunLaw{};
    if (name == IdelchikLaw::name) return IdelchikLaw{};
    if (name == ArmourCannonLaw::name) return ArmourCannonLaw{};
    if (name == MeasuredLaw::name) return read_measured_keys(table);
    if (name == ConstantLaw::name) return read_constant_law(table);
    return BraidStokesLaw{.inertia = table.boolean_or("inertia", BraidStokesLaw{}.inertia)};
}

}  // namespace braidzone
