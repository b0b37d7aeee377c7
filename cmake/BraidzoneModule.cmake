# braidzone_module(<name> SOURCES <files> [USES <modules>] [LIBRARIES <public>] [PRIVATE_LIBRARIES <private>])
#
# One target per module, braidzone::<name>. Headers are included as "<module>/<file>.hpp".
# Private libraries (CGAL, VTK, OpenVDB) do not reach the modules that use this one.

set(BRAIDZONE_WARNINGS -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wold-style-cast
  -Woverloaded-virtual -Wdouble-promotion -Werror)

function(braidzone_module name)
  cmake_parse_arguments(MODULE "" "" "SOURCES;USES;LIBRARIES;PRIVATE_LIBRARIES" ${ARGN})
  add_library(braidzone_${name} STATIC ${MODULE_SOURCES})
  add_library(braidzone::${name} ALIAS braidzone_${name})
  target_include_directories(braidzone_${name} PUBLIC ${PROJECT_SOURCE_DIR})
  target_compile_options(braidzone_${name} PRIVATE ${BRAIDZONE_WARNINGS})
  list(TRANSFORM MODULE_USES PREPEND braidzone::)
  target_link_libraries(braidzone_${name}
    PUBLIC ${MODULE_USES} ${MODULE_LIBRARIES}
    PRIVATE ${MODULE_PRIVATE_LIBRARIES})
endfunction()
