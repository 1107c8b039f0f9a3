#include "cli/KeptFiles.h"

#include "framework/store/FolderLock.h"
#include "framework/support/Error.h"
#include "framework/support/Fingerprint.h"
#include "framework/system/File.h"
#include "problems/formats/Formats.h"

#include <fstream>
#include <sstream>
#include <system_error>
#include <vector>

namespace mrpp
{

namespace
{

constexpr const char *kHeading = "file,holds";
constexpr std::string_view kSolutions = "solutions/";

std::string graphPath(const std::string &caseId)
{
    return "instances/" + caseId + ".graphml";
}

std::string instancePath(const std::string &caseId)
{
    return "instances/" + caseId + ".instance";
}

std::string solutionPath(const std::string &caseId, const std::string &planner)
{
    return std::string(kSolutions) + caseId + "." + fileSafe(planner) + ".csv";
}

bool hasSolution(const RunRecord &record)
{
    return record.status == PlannerStatus::solved || record.status == PlannerStatus::partial;
}

} // namespace

KeptList::KeptList(const std::filesystem::path &folder) : file_(folder / "kept-files.csv")
{
    std::error_code error;
    exists_ = std::filesystem::exists(file_, error);
    if (!exists_)
        return;
    std::istringstream lines(readFile(file_));
    for (std::string line; std::getline(lines, line);)
        if (const std::size_t comma = line.rfind(','); comma != std::string::npos && line != kHeading)
            entries_[line.substr(0, comma)] = line.substr(comma + 1); // the newest line of a file counts
}

void KeptList::add(const std::string &path, const std::string &key)
{
    entries_[path] = key;
    std::ofstream list(file_, std::ios::app);
    list << path << ',' << key << '\n';
    if (!list.flush())
        throw FileError({file_.string()}, "cannot be written");
}

void KeptList::save()
{
    std::string text = std::string(kHeading) + "\n";
    for (const auto &[path, key] : entries_)
        text.append(path).append(",").append(key).append("\n");
    writeFile(file_, text);
    exists_ = true;
}

KeptFiles::KeptFiles(const BenchmarkPlan &plan, std::filesystem::path folder)
    : plan_(plan), folder_(std::move(folder))
{}

void KeptFiles::prepare()
{
    if (list_)
        return;
    removeLeftovers();
    list_.emplace(folder_);
    if (!list_->exists())
        adopt(ResultStore(folder_, ResultStore::Access::read).records());
    list_->save();
}

void KeptFiles::write(const RunSpec &spec, const RunResult &result)
{
    if (!keepsAnything())
        return;
    prepare();
    FileSet files;
    if (plan_.keep.instances && result.instance && cases_.insert(spec.caseId).second)
    {
        const std::filesystem::path graph = folder_ / graphPath(spec.caseId);
        for (const std::string &path : {graphPath(spec.caseId), instancePath(spec.caseId)})
            list_->add(path, result.record.instanceFingerprint);
        saveGraph(files, graph, *result.instance->graph);
        saveInstance(files, folder_ / instancePath(spec.caseId), *result.instance, graph);
    }
    if (plan_.keep.solutions && hasSolution(result.record))
    {
        const std::string path = solutionPath(spec.caseId, plan_.planners[spec.planner].name);
        list_->add(path, spec.runKey);
        saveSolution(files, folder_ / path, result.solution);
    }
    files.commit();
}

void KeptFiles::followNames()
{
    if (!keepsAnything())
        return;
    const FolderLock lock(folder_);
    prepare();
    const ResultStore store(folder_, ResultStore::Access::read);
    const ResultTable results(plan_, store.records(),
                              [&store](const std::string &runKey) { return store.solution(runKey); });
    const std::map<std::string, Wanted> all = wanted(results);
    moveUnstored(all, store);
    writeMissing(all, results);
    removeStale(all, store);
    list_->save();
}

/// What was written before there was a list has the names that the runs had then.
void KeptFiles::adopt(const std::vector<RunRecord> &records)
{
    const auto note = [this](const std::string &path, const std::string &key)
    {
        std::error_code error;
        if (std::filesystem::exists(folder_ / path, error))
            list_->entries()[path] = key;
    };
    for (const RunRecord &record : records)
    {
        note(graphPath(record.caseId), record.instanceFingerprint);
        note(instancePath(record.caseId), record.instanceFingerprint);
        if (hasSolution(record))
            note(solutionPath(record.caseId, record.planner), record.runKey);
    }
}

std::map<std::string, KeptFiles::Wanted> KeptFiles::wanted(const ResultTable &results) const
{
    std::map<std::string, Wanted> all;
    for (const RunRecord &record : results.records())
    {
        if (plan_.keep.instances && !record.instanceFingerprint.empty())
            for (const std::string &path : {graphPath(record.caseId), instancePath(record.caseId)})
                all.insert_or_assign(path, Wanted{record.instanceFingerprint, &record});
        if (plan_.keep.solutions && hasSolution(record))
            all.insert_or_assign(solutionPath(record.caseId, record.planner), Wanted{record.runKey, &record});
    }
    return all;
}

bool KeptFiles::holds(const std::string &path, const std::string &key)
{
    const auto entry = list_->entries().find(path);
    std::error_code error;
    return entry != list_->entries().end() && entry->second == key &&
           std::filesystem::exists(folder_ / path, error);
}

/// Solutions that only their files hold are renamed. First all away, then all to their places, as names may
/// have been exchanged.
void KeptFiles::moveUnstored(const std::map<std::string, Wanted> &wanted, const ResultStore &store)
{
    std::map<std::string, std::string> places; // by key
    for (const auto &[path, key] : list_->entries())
        if (path.starts_with(kSolutions))
            places[key] = path;
    std::vector<std::pair<std::string, std::string>> moves;
    for (const auto &[path, want] : wanted)
    {
        const auto place = places.find(want.key);
        if (path.starts_with(kSolutions) && place != places.end() && place->second != path &&
            holds(place->second, want.key) && !store.solution(want.key))
            moves.emplace_back(place->second, path);
    }
    constexpr const char *kMoving = ".moving.csv";
    for (const auto &[from, to] : moves)
        std::filesystem::rename(folder_ / from, folder_ / (to + kMoving));
    for (const auto &[from, to] : moves)
        list_->entries().erase(from);
    for (const auto &[from, to] : moves)
    {
        std::filesystem::rename(folder_ / (to + kMoving), folder_ / to);
        list_->entries()[to] = wanted.at(to).key;
    }
}

void KeptFiles::writeMissing(const std::map<std::string, Wanted> &wanted, const ResultTable &results)
{
    for (const auto &[path, want] : wanted)
    {
        if (holds(path, want.key))
            continue;
        FileSet files;
        if (path.starts_with(kSolutions))
        {
            const auto solution = results.solution(*want.record);
            if (!solution)
                continue; // too large for the store, and of before there was a list
            saveSolution(files, folder_ / path, *solution);
        }
        else if (path == graphPath(want.record->caseId)) // both at once
        {
            const auto instance = results.instance(*want.record);
            if (!instance)
                continue;
            saveGraph(files, folder_ / path, *instance->graph);
            saveInstance(files, folder_ / instancePath(want.record->caseId), *instance, folder_ / path);
            list_->entries()[instancePath(want.record->caseId)] = want.key;
        }
        else
        {
            continue;
        }
        files.commit();
        list_->entries()[path] = want.key;
    }
}

void KeptFiles::removeStale(const std::map<std::string, Wanted> &wanted, const ResultStore &store)
{
    std::erase_if(list_->entries(),
                  [&](const auto &entry)
                  {
                      const auto &[path, key] = entry;
                      const bool isSolution = path.starts_with(kSolutions);
                      const bool isAsked = isSolution ? plan_.keep.solutions : plan_.keep.instances;
                      if (!isAsked || wanted.contains(path) || (isSolution && !store.solution(key)))
                          return false;
                      std::error_code error;
                      std::filesystem::remove(folder_ / path, error);
                      for (auto parent = std::filesystem::path(path).parent_path(); parent.has_parent_path();
                           parent = parent.parent_path())
                          std::filesystem::remove(folder_ / parent, error); // where it is empty now
                      return true;
                  });
}

/// Files that a killed campaign had not finished when it died.
void KeptFiles::removeLeftovers() const
{
    for (const char *part : {"instances", "solutions"})
    {
        std::vector<std::filesystem::path> leftovers;
        std::error_code error;
        for (const auto &entry : std::filesystem::recursive_directory_iterator(folder_ / part, error))
        {
            const std::filesystem::path extension = entry.path().extension();
            if (entry.is_regular_file() && extension != ".graphml" && extension != ".instance" &&
                extension != ".csv")
                leftovers.push_back(entry.path());
        }
        for (const std::filesystem::path &file : leftovers)
            std::filesystem::remove(file, error);
    }
}

std::string fileSafe(const std::string &name)
{
    constexpr std::string_view kSafe = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
    constexpr std::size_t kLongest = 60;
    std::string safe = name.substr(0, kLongest);
    for (char &c : safe)
        if (kSafe.find(c) == std::string_view::npos)
            c = '_';
    return safe == name ? name : safe + "." + Fingerprint().add(name).hex().substr(0, 8);
}

} // namespace mrpp
