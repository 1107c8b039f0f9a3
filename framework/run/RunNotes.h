#pragma once

#include "framework/run/RunRecord.h"

namespace mrpp
{

/// Says something of the run that is nobody's failure, in the added column `notes`.
inline void addNote(RunRecord &record, const std::string &text)
{
    Value &notes = record.extra["notes"];
    const auto *before = std::get_if<std::string>(&notes);
    notes = (before == nullptr ? "" : *before + "; ") + text;
}

} // namespace mrpp
