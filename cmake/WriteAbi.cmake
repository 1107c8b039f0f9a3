# cmake -D LIST=FILE -D VERSION=X.Y.Z -D FILE=AbiVersion.h -P WriteAbi.cmake
#
# Writes version and a hash of the headers that are named in LIST, one a line: plugins must be compiled with the
# same ones.
file(STRINGS "${LIST}" headers)
set(all "")
foreach(header IN LISTS headers)
    file(SHA256 "${header}" hash)
    string(APPEND all "${hash}\n")
endforeach()
string(SHA256 hash "${all}")
string(SUBSTRING "${hash}" 0 32 hash)
set(text "#pragma once

#define MRPP_ABI_TEXT_(x) #x
#define MRPP_ABI_TEXT(x) MRPP_ABI_TEXT_(x)
#define MRPP_ABI_VERSION \"${VERSION}\"
#ifndef MRPP_ABI_HEADERS
#define MRPP_ABI_HEADERS \"${hash}\"
#endif
")
file(CONFIGURE OUTPUT "${FILE}" CONTENT "${text}" @ONLY) # touched only where it differs
