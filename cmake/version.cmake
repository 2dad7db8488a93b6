# Writes the version source whenever the commit has changed; run before each build.
execute_process(COMMAND git describe --always --dirty WORKING_DIRECTORY ${SOURCE_DIR} OUTPUT_VARIABLE WASHFSI_GIT
                OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
configure_file(${SOURCE_DIR}/lib/washfsi/simulation/version.cpp.in ${OUTPUT} @ONLY)
