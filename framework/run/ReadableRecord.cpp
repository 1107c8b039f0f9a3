#include "framework/run/ReadableRecord.h"

#include "framework/support/ReadableText.h"

namespace mrpp
{

void makeReadable(RunRecord &record)
{
    for (std::string *text : {&record.reason, &record.unsolvableReason, &record.repeatable})
        *text = readable(*text);
    for (auto &[name, value] : record.extra)
        if (auto *text = std::get_if<std::string>(&value))
            *text = readable(*text);
}

} // namespace mrpp
