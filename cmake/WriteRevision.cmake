# cmake -D SOURCE=DIR -D FILE=Revision.h -P WriteRevision.cmake
#
# Writes the git revision of DIR, with "-dirty" where its files differ from it, or an empty text where DIR is
# not the top of a checkout.
set(revision "")
find_package(Git QUIET)
if(GIT_FOUND AND EXISTS "${SOURCE}/.git")
    execute_process(COMMAND "${GIT_EXECUTABLE}" describe --always --dirty --exclude=* --abbrev=12
        WORKING_DIRECTORY "${SOURCE}" OUTPUT_VARIABLE revision OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
set(text "#define MRPP_REVISION \"${revision}\"\n")
file(CONFIGURE OUTPUT "${FILE}" CONTENT "${text}" @ONLY) # touched only where it differs
