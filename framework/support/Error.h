#pragma once
/// \file
/// The errors that a user can cause, each knowing where in which file it happened.
///
/// Malformed input is reported as `file:line:column: what is wrong, and what would be right`.
/// Expected ends of a run (timeout, infeasible, …) are never exceptions: see PlannerStatus.h.

#include <stdexcept>
#include <string>
#include <string_view>

namespace mrpp
{

/// A place in a text file. Lines and columns count from 1; 0 means unknown.
struct SourceLocation
{
    std::string file;
    std::size_t line = 0;
    std::size_t column = 0;

    /// `file:line:column`, without the parts that are unknown.
    [[nodiscard]] std::string toString() const;
};

/// Input that a person or another program gave and that cannot be used. The command line ends with
/// exit code 2 and this message.
class InputError : public std::runtime_error
{
public:
    /// \param what what is wrong, and what would be right
    explicit InputError(const std::string &what);
    InputError(SourceLocation where, const std::string &what);

    [[nodiscard]] const SourceLocation &where() const { return where_; }

    /// The message without the location.
    [[nodiscard]] const std::string &complaint() const { return complaint_; }

private:
    SourceLocation where_;
    std::string complaint_;
};

/// A graph, map, instance, scenario or solution file that breaks its format's rules.
class ParseError : public InputError
{
public:
    using InputError::InputError;
};

/// A plan that breaks the plan's grammar.
class PlanError : public InputError
{
public:
    using InputError::InputError;
};

/// A parameter that does not exist or has a value outside its range.
class ParamError : public InputError
{
public:
    using InputError::InputError;
};

/// A number of robots that a graph cannot hold. Where the graph was drawn by chance and the plan sweeps
/// beyond it, such a point is no malformed plan: its runs are recorded as `unsupported`.
class DoesNotFit : public InputError
{
public:
    using InputError::InputError;
};

/// A file or folder that cannot be read or written; also exit code 2.
class FileError : public InputError
{
public:
    using InputError::InputError;
};

} // namespace mrpp
