# Compiling a test or an example takes half a minute, most of it for what the
# others instantiate as well. So several become one unit, each in a namespace of
# its own; their includes stand before.

# anisotropic_mesh_2_add_programs(TARGET FILE...): the executable TARGET, whose
# first argument is the name of the program to run. The programs are targets
# too, as small ones for those who work at one of them; `all` leaves them out.
function(anisotropic_mesh_2_add_programs target)
  set(directives "")
  set(programs "")
  set(calls "")
  foreach(file IN LISTS ARGN)
    get_filename_component(name ${file} NAME_WE)
    anisotropic_mesh_2_add_executable(${name} ${file})
    set_target_properties(${name} PROPERTIES EXCLUDE_FROM_ALL ON)
    file(STRINGS ${file} lines REGEX "^#") # conditional ones with their conditions
    list(JOIN lines "\n" lines)
    string(APPEND directives "${lines}\n")
    string(APPEND programs "namespace ${name} {\n#include \"${file}\"\n}\n")
    string(APPEND calls "  if(name == \"${name}\")\n    return call(${name}::main, argc - 1, argv + 1);\n")
  endforeach()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${ARGN})
  file(CONFIGURE OUTPUT ${target}.cpp @ONLY CONTENT
"#include <iostream>
#include <string>
@directives@
@programs@
int call(int (*program)(), int, char**) { return program(); }
int call(int (*program)(int, char**), int argc, char** argv) { return program(argc, argv); }

int main(int argc, char** argv)
{
  const std::string name = argc > 1 ? argv[1] : \"\";
@calls@  std::cerr << \"there is no program \" << name << std::endl;
  return 1;
}
")
  anisotropic_mesh_2_add_executable(${target} ${CMAKE_CURRENT_BINARY_DIR}/${target}.cpp)
  target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
endfunction()
