#include "export/foam_dictionaries.hpp"

#include "export/foam_format.hpp"

#include <fmt/format.h>

namespace braidzone {

namespace {

std::string system_header(const char* object)
{
    return foam_header("dictionary", "system", object);
}

}  // namespace

std::string block_mesh_dict(const FoamMeshingPlan& plan)
{
    const Vec3 lower = plan.block.lower, upper = plan.block.upper();
    std::string vertices;
    // OpenFOAM's order: the lower face anticlockwise, then the upper one.
    for (const double z : {lower.z(), upper.z()})
        for (const auto& [x, y] : {std::pair{lower.x(), lower.y()},
                                   {upper.x(), lower.y()},
                                   {upper.x(), upper.y()},
                                   {lower.x(), upper.y()}})
            vertices += "    " + foam_vector(Vec3(x, y, z)) + "\n";
    const auto& n = plan.block.num_cells;
    return system_header("blockMeshDict") +
           fmt::format(R"(// The block that snappyHexMesh carves the lumen from, in metres.
scale   1;

vertices
(
{vertices});

blocks
(
    hex (0 1 2 3 4 5 6 7) ({nx} {ny} {nz}) simpleGrading (1 1 1)
);

edges ();

boundary
(
    background
    {{
        type patch;
        faces
        (
            (0 3 2 1) (4 5 6 7) (0 1 5 4) (1 2 6 5) (2 3 7 6) (3 0 4 7)
        );
    }}
);

mergePatchPairs ();
)",
                       fmt::arg("vertices", vertices), fmt::arg("nx", n[0]), fmt::arg("ny", n[1]),
                       fmt::arg("nz", n[2]));
}

std::string surface_feature_extract_dict()
{
    return system_header("surfaceFeatureExtractDict") +
           R"(// Edges at the openings and other edges sharper than 180 - 150 = 30 degrees.
vessel.stl
{
    extractionMethod    extractFromSurface;
    extractFromSurfaceCoeffs
    {
        includedAngle   150;
    }
    writeObj            no;
}
)";
}

std::string snappy_hex_mesh_dict(const FoamMeshingPlan& plan)
{
    const int level = plan.surface_level;
    std::string names = "            wall { name wall; }\n";
    std::string patches = fmt::format(
        "                wall {{ level ({0} {0}); patchInfo {{ type wall; }} }}\n", level);
    for (const std::string& opening : plan.openings) {
        names += fmt::format("            {0} {{ name {0}; }}\n", opening);
        patches +=
            fmt::format("                {0} {{ level ({1} {1}); patchInfo {{ type patch; }} }}\n",
                        opening, level);
    }
    const bool has_device = plan.device_distance > 0.0;
    const std::string device_geometry =
        has_device
            ? "    device.stl\n    {\n        type triSurfaceMesh;\n        name device;\n    }\n"
            : "";
    const std::string device_region =
        has_device ? fmt::format("        device {{ mode distance; levels (({} {})); }}\n",
                                 plan.device_distance, plan.device_level)
                   : "";
    const std::string device_surface =
        plan.follows_device
            ? fmt::format(
                  "        device {{ level ({0} {0}); faceZone device; faceType internal; }}\n",
                  plan.device_level)
            : "";
    return system_header("snappyHexMeshDict") +
           fmt::format(R"(castellatedMesh true;
snap            true;
addLayers       false;

geometry
{{
    vessel.stl
    {{
        type triSurfaceMesh;
        name vessel;
        regions
        {{
{names}        }}
    }}
{device_geometry}}}

castellatedMeshControls
{{
    maxLocalCells       2000000;
    maxGlobalCells      10000000;
    minRefinementCells  0;
    nCellsBetweenLevels 2;
    resolveFeatureAngle 30;
    allowFreeStandingZoneFaces true;
    features
    (
        {{ file "vessel.eMesh"; level {level}; }}
    );
    refinementSurfaces
    {{
{device_surface}        vessel
        {{
            level ({level} {level});
            regions
            {{
{patches}            }}
        }}
    }}
    refinementRegions
    {{
{device_region}    }}
    // At a third of a cell along each axis: on no face at any level.
    locationInMesh {inside};
}}

snapControls
{{
    nSmoothPatch        3;
    tolerance           2.0;
    nSolveIter          50;
    nRelaxIter          5;
    nFeatureSnapIter    10;
    implicitFeatureSnap false;
    explicitFeatureSnap true;
    multiRegionFeatureSnap false;
}}

addLayersControls
{{
    relativeSizes       true;
    layers              {{}}
    expansionRatio      1;
    finalLayerThickness 0.3;
    minThickness        0.1;
    nGrow               0;
    featureAngle        60;
    nRelaxIter          3;
    nSmoothSurfaceNormals 1;
    nSmoothNormals      3;
    nSmoothThickness    10;
    maxFaceThicknessRatio 0.5;
    maxThicknessToMedialRatio 0.3;
    minMedianAxisAngle  90;
    nBufferCellsNoExtrude 0;
    nLayerIter          50;
}}

meshQualityControls
{{
    maxNonOrtho         65;
    maxBoundarySkewness 20;
    maxInternalSkewness 4;
    maxConcave          80;
    // The usual 1e-13 m^3 is larger than good cells of 0.05 mm.
    minVol              1e-18;
    minTetQuality       1e-15;
    minArea             -1;
    minTwist            0.02;
    minDeterminant      0.001;
    minFaceWeight       0.05;
    minVolRatio         0.01;
    minTriangleTwist    -1;
    nSmoothScale        4;
    errorReduction      0.75;
}}

mergeTolerance 1e-6;
)",
                       fmt::arg("names", names), fmt::arg("device_geometry", device_geometry),
                       fmt::arg("level", level), fmt::arg("patches", patches),
                       fmt::arg("device_region", device_region),
                       fmt::arg("device_surface", device_surface),
                       fmt::arg("inside", foam_vector(plan.inside)));
}

}  // namespace braidzone
