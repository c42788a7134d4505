# Third-party parts: Debian 12 packages or vcpkg ports, each behind one target name.
find_package(Threads REQUIRED)
find_package(fmt CONFIG REQUIRED)
find_package(glm CONFIG REQUIRED)
find_package(nlohmann_json CONFIG REQUIRED)
find_package(CLI11 CONFIG REQUIRED)
find_package(GTest REQUIRED)
find_package(OpenEXR CONFIG REQUIRED)
find_package(glfw3 CONFIG REQUIRED)
find_package(PkgConfig QUIET)

# Embree 4 where there is one, else 3.13; truth/embree.h smooths the difference.
find_package(embree 4 CONFIG QUIET)
if(NOT embree_FOUND)
  find_package(embree 3 CONFIG REQUIRED)
endif()
string(REGEX MATCH "^[0-9]+" PENUMBRA_EMBREE_MAJOR "${embree_VERSION}")

# Dear ImGui: a CMake package under vcpkg, pkg-config only on Debian.
find_package(imgui CONFIG QUIET)
add_library(penumbra_imgui INTERFACE)
if(imgui_FOUND)
  target_link_libraries(penumbra_imgui INTERFACE imgui::imgui)
else()
  pkg_check_modules(IMGUI REQUIRED IMPORTED_TARGET imgui)
  find_path(IMGUI_BACKENDS imgui_impl_glfw.h PATH_SUFFIXES imgui/backends REQUIRED)
  find_path(IMGUI_HEADERS imgui.h PATH_SUFFIXES imgui REQUIRED)
  target_include_directories(penumbra_imgui INTERFACE ${IMGUI_HEADERS} ${IMGUI_BACKENDS})
  target_link_libraries(penumbra_imgui INTERFACE PkgConfig::IMGUI stb)  # imgui draws text with stb
endif()

find_package(tinyobjloader CONFIG REQUIRED)
find_path(STB_HEADERS stb/stb_image_write.h)
if(NOT STB_HEADERS)
  find_path(STB_HEADERS stb_image_write.h REQUIRED)
endif()

# The OpenGL loader is generated: core 4.1 and nothing past it, so that code which runs here also
# compiles on student Macs.
find_program(GLAD glad REQUIRED)
set(GLAD_DIR ${CMAKE_BINARY_DIR}/glad)
if(NOT EXISTS ${GLAD_DIR}/src/gl.c)
  execute_process(
    COMMAND ${GLAD} --api gl:core=4.1 --reproducible --out-path ${GLAD_DIR}
            --extensions GL_KHR_debug,GL_EXT_texture_filter_anisotropic c
    COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET ERROR_QUIET)
endif()
add_library(penumbra_glad OBJECT ${GLAD_DIR}/src/gl.c)
target_include_directories(penumbra_glad SYSTEM PUBLIC ${GLAD_DIR}/include)
