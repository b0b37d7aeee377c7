#pragma once

#include "core/vessel.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace braidzone {

/// What to do with openings that are not flat on the faces of an axis-aligned box.
enum class OpeningFaces {
    as_is,
    extended,    ///< each is continued to the face that it looks at
    extended_z,  ///< the inlet to one face across z, all outlets to the opposite one
};

inline constexpr std::array all_opening_faces{OpeningFaces::as_is, OpeningFaces::extended,
                                              OpeningFaces::extended_z};

/// Its name in the case file.
std::string_view name_of(OpeningFaces faces);

struct ExtensionOptions {
    OpeningFaces faces = OpeningFaces::extended;
    int inlet = 0;           ///< index of the opening that is the inlet
    double clearance = 0.0;  ///< between a tube and other walls, and beyond the vessel [m]; > 0
};

/// A tube that continues an opening.
struct OpeningTube {
    int opening = 0;                 ///< index in the vessel
    Vec3 direction = Vec3::UnitX();  ///< along an axis, out of the lumen
    double turn = 0.0;               ///< angle of its bend [rad]
    double length = 0.0;             ///< along its middle [m]
};

struct ExtendedVessel {
    Vessel vessel;                   ///< openings in the order of the original's
    std::vector<OpeningTube> tubes;  ///< of the openings that are continued
};

/// Continues openings until they meet the faces of an axis-aligned box that holds all of the
/// vessel.
///
/// The opening's own outline is swept along its normal for the clearance, then along an arc whose
/// radius is twice the outline's, then along an axis to the face. (In Poiseuille flow, such a bend
/// of a few degrees to 55 loses little; a tube of one diameter lets the profile settle.) All
/// openings to one face end in one plane, beyond everything else by the clearance. An outline that
/// lies flat in the outermost plane already stays as it is.
///
/// With `extended` an opening turns to the axis nearest to its normal; if that tube would come
/// nearer than the clearance to the vessel or to another tube, to the next one, up to 100 degrees.
///
/// @throws InputError if the clearance is not positive; GeometryError if an opening has no way to a
///         face, with its place
ExtendedVessel extend_openings(const Vessel& vessel, const ExtensionOptions& options);

/// One sentence for each tube.
std::vector<std::string> describe(const std::vector<OpeningTube>& tubes, const Vessel& vessel);

}  // namespace braidzone
