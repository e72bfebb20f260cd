# Writes OUT, a source file that holds FOLDER's page.css and page.js.
file(READ ${FOLDER}/page.css css)
file(READ ${FOLDER}/page.js js)
file(WRITE ${OUT} "#include <groundtruth/page/assets.hpp>

namespace groundtruth::page {

const char* const style_sheet = R\"css(${css})css\";
const char* const script = R\"js(${js})js\";

}  // namespace groundtruth::page
")
