#include "cli/Commands.h"
#include "cli/Interruption.h"
#include "cli/WorkLine.h"
#include "framework/system/File.h"
#include "problems/formats/Conversion.h"

#include <iostream>

namespace mrpp
{

ExitCode convert(const ConvertArguments &arguments)
{
    FileSet files;
    WorkLine line;
    Interruption interruption(std::chrono::milliseconds(0), [&files] { files.abandon(); });
    const Conversion done = convertFile({arguments.in, arguments.out, arguments.graph, arguments.instance,
                                         arguments.format, arguments.passability},
                                        files, line.listener());
    interruption.waitFromNowOn();
    line.clear();
    for (const std::string &note : done.notes)
        std::cerr << "note: " << note << '\n';
    for (const std::filesystem::path &file : done.files)
        std::cout << "wrote " << file.string() << '\n';
    return ExitCode::done;
}

} // namespace mrpp
