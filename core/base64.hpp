#pragma once

#include <string>
#include <string_view>

namespace braidzone {

/// Bytes in base 64 (RFC 4648, section 4), as a page carries a picture within itself.
std::string base64_of(std::string_view bytes);

}  // namespace braidzone
