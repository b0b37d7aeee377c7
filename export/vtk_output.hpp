#pragma once

#include "core/length_unit.hpp"
#include "core/vector.hpp"

#include <filesystem>
#include <string>
#include <vector>

class vtkDataObject;
class vtkFieldData;
class vtkXMLWriter;

namespace braidzone {

/// Adds an array of one number a tuple, in double precision.
void add_numbers(vtkFieldData& fields, const std::string& name, const std::vector<double>& values);

/// Adds an array of two or three numbers a tuple, in double precision.
void add_numbers(vtkFieldData& fields, const std::string& name, const std::vector<Vec2>& values);
void add_numbers(vtkFieldData& fields, const std::string& name, const std::vector<Vec3>& values);

/// Adds an array of whole numbers, 0 to 255 or any.
void add_flags(vtkFieldData& fields, const std::string& name, const std::vector<char>& values);
void add_integers(vtkFieldData& fields, const std::string& name, const std::vector<int>& values);

/// The unit of an array, "1" for a number without unit.
struct ArrayUnit {
    std::string array;
    std::string unit;
};

/// States the units in the field data: strings `length_unit` (of coordinates) and, for each array,
/// `unit:<array>`.
void add_units(vtkDataObject& data, const LengthUnit& length_unit,
               const std::vector<ArrayUnit>& units);

/// Writes data as VTK XML: binary, compressed, the same bytes from run to run.
/// @throws IoError if the file cannot be written
void write_vtk_xml(const std::filesystem::path& path, vtkXMLWriter& writer, vtkDataObject& data);

/// The same for a writer whose input is set already.
void write_vtk_xml(const std::filesystem::path& path, vtkXMLWriter& writer);

}  // namespace braidzone
