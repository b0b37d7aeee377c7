# Every library comes from Debian 12's packages (list: packages.txt beside this file).

find_package(Eigen3 3.4 REQUIRED)
find_package(fmt 9 REQUIRED)
set(BLA_VENDOR OpenBLAS)
find_package(LAPACK REQUIRED)
find_package(Ceres 2.1 REQUIRED)
find_package(TBB REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(CLI11 2.1 REQUIRED)
find_package(CGAL 5.5 REQUIRED)
find_package(VTK 9.1 REQUIRED COMPONENTS
  CommonCore CommonDataModel CommonExecutionModel IOGeometry IOImage IOLegacy IOPLY IOXML)
list(APPEND CMAKE_MODULE_PATH /usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/cmake/OpenVDB)
find_package(OpenVDB 10 REQUIRED COMPONENTS openvdb)

# CGAL sets CMAKE_BUILD_TYPE-dependent flags of its own; the project's presets decide.
set(CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE TRUE)
