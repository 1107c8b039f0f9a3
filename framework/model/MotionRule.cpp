#include "framework/model/MotionRule.h"

namespace mrpp
{

std::string_view toString(MotionRule rule)
{
    switch (rule)
    {
    case MotionRule::pebble:
        return "pebble";
    case MotionRule::parallel:
        return "parallel";
    case MotionRule::following:
        return "following";
    case MotionRule::rotation:
        return "rotation";
    }
    return "?";
}

std::optional<MotionRule> motionRule(std::string_view name)
{
    for (const MotionRule rule :
         {MotionRule::pebble, MotionRule::parallel, MotionRule::following, MotionRule::rotation})
        if (name == toString(rule))
            return rule;
    return std::nullopt;
}

} // namespace mrpp
