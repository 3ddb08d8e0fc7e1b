# Writes OUTPUT.cpp, the source of cnc::identity::version(), and OUTPUT.txt with the same text, if
# the version differs from theirs. Run with cmake -DSOURCE=… -DVERSION=… -DOUTPUT=… -P.
cmake_policy(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/describe_version.cmake)
kerfline_describe_version(version ${SOURCE} ${VERSION})
file(CONFIGURE OUTPUT ${OUTPUT}.txt CONTENT "@version@\n" @ONLY)
file(CONFIGURE OUTPUT ${OUTPUT}.cpp CONTENT "#include \"firmware/protocol/identity.hpp\"

std::string_view cnc::identity::version() { return \"@version@\"; }
" @ONLY)
