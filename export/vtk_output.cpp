#include "export/vtk_output.hpp"

#include "core/error.hpp"

#include <fmt/format.h>
#include <vtkDataObject.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLWriter.h>

#include <fstream>

namespace braidzone {

namespace {

/// The fastest level: higher ones save a few percent of such data and cost several times as much.
constexpr int compression_level = 1;

template <typename VectorType>
void add_vectors(vtkFieldData& fields, const std::string& name,
                 const std::vector<VectorType>& values)
{
    constexpr int size = VectorType::SizeAtCompileTime;
    vtkNew<vtkDoubleArray> array;
    array->SetName(name.c_str());
    array->SetNumberOfComponents(size);
    array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
    for (std::size_t i = 0; i < values.size(); ++i) {
        array->SetTypedTuple(static_cast<vtkIdType>(i), values[i].data());
    }
    fields.AddArray(array);
}

template <typename Array, typename Value>
void add_values(vtkFieldData& fields, const std::string& name, const std::vector<Value>& values)
{
    vtkNew<Array> array;
    array->SetName(name.c_str());
    array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
    for (std::size_t i = 0; i < values.size(); ++i) {
        array->SetValue(static_cast<vtkIdType>(i),
                        static_cast<typename Array::ValueType>(values[i]));
    }
    fields.AddArray(array);
}

void write_through_string(const std::filesystem::path& path, vtkXMLWriter& writer)
{
    // Because the writer tells of a failing file on stderr only.
    writer.WriteToOutputStringOn();
    writer.Write();
    const std::string content = writer.GetOutputString();
    std::ofstream file(path, std::ios::binary);
    file.write(content.data(), static_cast<std::streamsize>(content.size()));
    file.close();
    if (!file) throw IoError(fmt::format("{}: cannot be written", path.string()));
}

}  // namespace

void add_numbers(vtkFieldData& fields, const std::string& name, const std::vector<double>& values)
{
    add_values<vtkDoubleArray>(fields, name, values);
}

void add_numbers(vtkFieldData& fields, const std::string& name, const std::vector<Vec2>& values)
{
    add_vectors(fields, name, values);
}

void add_numbers(vtkFieldData& fields, const std::string& name, const std::vector<Vec3>& values)
{
    add_vectors(fields, name, values);
}

void add_flags(vtkFieldData& fields, const std::string& name, const std::vector<char>& values)
{
    add_values<vtkUnsignedCharArray>(fields, name, values);
}

void add_integers(vtkFieldData& fields, const std::string& name, const std::vector<int>& values)
{
    add_values<vtkIntArray>(fields, name, values);
}

void add_units(vtkDataObject& data, const LengthUnit& length_unit,
               const std::vector<ArrayUnit>& units)
{
    const auto add_string = [&](const std::string& name, const std::string& value) {
        vtkNew<vtkStringArray> array;
        array->SetName(name.c_str());
        array->InsertNextValue(value);
        data.GetFieldData()->AddArray(array);
    };
    add_string("length_unit", length_unit.name);
    for (const ArrayUnit& unit : units)
        add_string("unit:" + unit.array, unit.unit);
}

void write_vtk_xml(const std::filesystem::path& path, vtkXMLWriter& writer, vtkDataObject& data)
{
    writer.SetInputDataObject(&data);
    write_vtk_xml(path, writer);
}

void write_vtk_xml(const std::filesystem::path& path, vtkXMLWriter& writer)
{
    writer.SetCompressorTypeToZLib();
    writer.SetCompressionLevel(compression_level);
    writer.SetDataModeToAppended();
    writer.EncodeAppendedDataOff();
    write_through_string(path, writer);
}

}  // namespace braidzone
