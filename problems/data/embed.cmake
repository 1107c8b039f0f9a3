# cmake -DNAMES=a;b -DFOLDER=dir -DOUTPUT=file.cpp -P embed.cmake
# Writes NAME.graphml and NAME.instance of each name as string literals.
set(rows "")
foreach(name IN LISTS NAMES)
    file(READ "${FOLDER}/${name}.graphml" graph)
    file(READ "${FOLDER}/${name}.instance" instance)
    string(APPEND rows "    {\"${name}\", R\"file(${graph})file\",\n     R\"file(${instance})file\"},\n")
endforeach()
file(WRITE "${OUTPUT}" "// Written by problems/data/embed.cmake from the files beside it.
#include \"problems/data/SmallProblems.h\"

namespace mrpp
{

namespace
{
constexpr SmallProblemData kProblems[] = {
${rows}};
} // namespace

std::span<const SmallProblemData> smallProblems()
{
    return kProblems;
}

} // namespace mrpp
")
