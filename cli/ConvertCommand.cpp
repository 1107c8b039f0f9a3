#include "cli/Commands.h"
#include "problems/formats/Conversion.h"

#include <iostream>

namespace mrpp
{

ExitCode convert(const ConvertArguments &arguments)
{
    const Conversion done = convertFile({arguments.in, arguments.out, arguments.graph, arguments.instance,
                                         arguments.format, arguments.passability});
    for (const std::string &note : done.notes)
        std::cerr << "note: " << note << '\n';
    for (const std::filesystem::path &file : done.files)
        std::cout << "wrote " << file.string() << '\n';
    return ExitCode::done;
}

} // namespace mrpp
