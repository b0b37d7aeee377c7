#include "export/npy_header.hpp"

#include <fmt/format.h>

namespace braidzone {

std::string npy_header(const std::string& type, const std::string& shape, NpyOrder order)
{
    constexpr std::size_t alignment = 64, fixed_size = 10;
    std::string text = fmt::format("{{'descr': '{}', 'fortran_order': {}, 'shape': ({}), }}", type,
                                   order == NpyOrder::first_fastest ? "True" : "False", shape);
    while ((fixed_size + text.size() + 1) % alignment != 0)
        text += ' ';
    text += '\n';
    std::string header = "\x93NUMPY";
    header += '\x01';
    header += '\x00';
    header += static_cast<char>(text.size() % 256);
    header += static_cast<char>(text.size() / 256);
    return header + text;
}

}  // namespace braidzone
