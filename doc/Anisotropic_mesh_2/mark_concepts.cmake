# Run after doxygen in the folder of the pages: those of concepts, which doxygen takes for classes,
# are titled as concepts and lose the file that nobody includes.
file(GLOB pages class*.html)
foreach(page IN LISTS pages)
  file(READ ${page} text)
  if(text MATCHES "<div class=\"ingroups\">[^\n]*group__PkgAnisotropicMesh2Concepts")
    string(REPLACE " Class Reference" " Concept Reference" text "${text}")
    string(REGEX REPLACE "<p><code>#include &lt;[^\n]*</code></p>" "" text "${text}")
    file(WRITE ${page} "${text}")
  endif()
endforeach()
