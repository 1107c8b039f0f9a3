#pragma once
/// \file
/// What a long computation gets from its caller: when it has to stop, and whom it tells how far it is.
///
/// \code
/// for (Robot r = 0; r < robots; ++r)
/// {
///     if (supervision.mustStop("lower bounds", r, robots))
///         return std::nullopt;
///     …
/// }
/// \endcode

#include "framework/support/TerminationCondition.h"

#include <cstddef>
#include <functional>
#include <string_view>

namespace mrpp
{

struct Supervision
{
    /// Told now and then how much of a work is done. Called often: it must be cheap.
    using Listener = std::function<void(std::string_view work, std::size_t done, std::size_t total)>;

    TerminationCondition stop = {};
    Listener listener = {};

    /// Tells the listener, and asks whether to stop.
    [[nodiscard]] bool mustStop(std::string_view work, std::size_t done, std::size_t total) const
    {
        if (listener)
            listener(work, done, total);
        return stop();
    }
};

} // namespace mrpp
