#include "export/foam_function.hpp"

#include <fmt/format.h>

namespace braidzone {

std::string value_function(const FoamValue& value)
{
    return fmt::format(R"({}
{{
    type            {};
    libs            ("libfieldFunctionObjects.so");
    regionType      {};
    name            {};
    operation       {};
    fields          ({});
    writeFields     no;
    log             no;
}}
)",
                       value.name, value.type, value.region, value.part, value.operation,
                       value.field);
}

}  // namespace braidzone
