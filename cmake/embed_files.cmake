# Script behind ballpit_embed(): writes HEADER and SOURCE from FILES (separated by |).
string(REPLACE "|" ";" files "${FILES}")
file(WRITE ${HEADER} "#pragma once
#include <vector>

#include \"core/file.h\"
namespace ballpit { const std::vector<EmbeddedFile>& ${NAME}(); }
")
set(entries "")
foreach(file IN LISTS files)
  get_filename_component(base ${file} NAME)
  file(READ ${file} text)
  string(APPEND entries "    {\"${base}\", R\"ballpit(${text})ballpit\"},\n")
endforeach()
file(WRITE ${SOURCE} "#include \"${NAME}.h\"
namespace ballpit {
const std::vector<EmbeddedFile>& ${NAME}() {
  static const std::vector<EmbeddedFile> files = {
${entries}  };
  return files;
}
}
")
