# Script behind ballpit_embed_bytes(): writes HEADER and SOURCE from FILE.
file(WRITE ${HEADER} "#pragma once
#include <cstddef>
namespace ballpit {
const unsigned char* ${NAME}();
size_t ${NAME}_size();
}
")
file(READ ${FILE} hex HEX)
string(REGEX REPLACE "(..)" "0x\\1," bytes "${hex}")
file(WRITE ${SOURCE} "#include \"${NAME}.h\"
namespace ballpit {
static const unsigned char kBytes[] = {${bytes}};
const unsigned char* ${NAME}() { return kBytes; }
size_t ${NAME}_size() { return sizeof(kBytes); }
}
")
