#include "core/csv_reader.hpp"

#include <fmt/format.h>

namespace braidzone {

CsvReader::CsvReader(const std::filesystem::path& path) : path_(path), file_(path)
{
    if (!file_) throw IoError(fmt::format("{} cannot be read", path.string()));
    header_ = next().value_or("");
    line_number_ = 1;
}

std::optional<std::string> CsvReader::next()
{
    std::string line;
    if (!std::getline(file_, line)) {
        if (file_.bad()) throw IoError(fmt::format("{} cannot be read to its end", path_.string()));
        return std::nullopt;
    }
    ++line_number_;
    if (line.ends_with('\r')) line.pop_back();
    return line;
}

InputError CsvReader::refusal(int line, const std::string& finding) const
{
    return InputError(fmt::format("{}:{}: {}", path_.string(), line, finding));
}

InputError CsvReader::refusal(const std::string& finding) const
{
    return refusal(line_number_, finding);
}

}  // namespace braidzone
