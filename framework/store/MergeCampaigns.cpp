#include "framework/store/MergeCampaigns.h"

#include "framework/store/FolderLock.h"
#include "framework/store/MergeStores.h"
#include "framework/store/Provenance.h"
#include "framework/store/ResultSchema.h"
#include "framework/support/Error.h"
#include "framework/system/File.h"

#include <algorithm>
#include <sstream>

namespace mrpp
{

namespace
{

namespace fs = std::filesystem;

constexpr const char *kPlan = "plan.yaml";
constexpr const char *kProvenance = "provenance.json";
constexpr const char *kStore = "results.sqlite";

/// What a folder says about its campaign.
struct Campaign
{
    fs::path folder;
    std::string plan;
    Provenance provenance;
};

bool isThere(const fs::path &path)
{
    std::error_code error;
    return fs::exists(path, error);
}

Campaign campaignIn(const fs::path &folder)
{
    if (!isThere(folder / kPlan) || !isThere(folder / kProvenance) || !isThere(folder / kStore))
        throw FileError({folder.string()},
                        "holds no campaign; `mrppsim run PLAN -o DIR --shard i/n` makes one");
    const fs::path provenance = folder / kProvenance;
    return {folder, readFile(folder / kPlan), Provenance::fromJson(readFile(provenance), provenance)};
}

/// Throws where the plans are not the same text, at the first line that differs.
void checkSamePlan(const Campaign &a, const Campaign &b)
{
    if (a.plan == b.plan)
        return;
    std::istringstream linesOfA(a.plan);
    std::istringstream linesOfB(b.plan);
    std::string inA;
    std::string inB;
    std::size_t line = 0;
    bool moreA = true;
    bool moreB = true;
    do
    {
        ++line;
        moreA = static_cast<bool>(std::getline(linesOfA, inA));
        moreB = static_cast<bool>(std::getline(linesOfB, inB));
    } while (moreA && moreB && inA == inB);
    const auto shown = [](bool more, const std::string &text)
    { return more ? "'" + text + "'" : std::string("the end"); };
    throw InputError({(b.folder / kPlan).string(), line, 1},
                     "here is " + shown(moreB, inB) + ", but " + shown(moreA, inA) + " in " +
                         (a.folder / kPlan).string() + "; only parts of one campaign can be merged");
}

/// Adds a word to a list with commas, once.
void join(std::string &list, const std::string &word)
{
    if ((", " + list + ", ").find(", " + word + ", ") == std::string::npos)
        list += (list.empty() ? "" : ", ") + word;
}

/// The first campaign's, over the time and the machines of all.
Provenance joined(const std::vector<Campaign> &campaigns)
{
    Provenance all = campaigns.front().provenance;
    for (const Campaign &campaign : campaigns)
    {
        const Provenance &one = campaign.provenance;
        join(all.host, one.host);
        join(all.cpu, one.cpu);
        all.started = std::min(all.started, one.started);
        if (all.finished.empty() || one.finished.empty())
            all.finished.clear();
        else
            all.finished = std::max(all.finished, one.finished);
    }
    return all;
}

std::string programOf(const Provenance &provenance)
{
    return provenance.version + (provenance.revision.empty() ? "" : " (" + provenance.revision + ")");
}

std::vector<std::string> notesOn(const std::vector<Campaign> &campaigns)
{
    std::vector<std::string> notes;
    const Campaign &first = campaigns.front();
    for (const Campaign &other : campaigns)
        if (programOf(other.provenance) != programOf(first.provenance))
            notes.push_back(other.folder.string() + " ran under version " + programOf(other.provenance) +
                            ", " + first.folder.string() + " under " + programOf(first.provenance));
    return notes;
}

/// Instances and solutions that the plan keeps as files.
void takeKeptFiles(const fs::path &from, const fs::path &to)
{
    for (const char *part : {"instances", "solutions"})
    {
        if (!isThere(from / part))
            continue;
        for (const auto &entry : fs::recursive_directory_iterator(from / part))
        {
            const fs::path target = to / part / entry.path().lexically_relative(from / part);
            const fs::path extension = entry.path().extension();
            const bool isWhole = extension == ".graphml" || extension == ".instance" || extension == ".csv";
            if (entry.is_regular_file() && isWhole && !isThere(target))
                writeFile(target, readFile(entry.path()));
        }
    }
}

/// All of it into a folder that is there, and may itself be among the campaigns.
MergedCampaign mergeInto(const fs::path &out, const std::vector<Campaign> &campaigns)
{
    const FolderLock lock(out);
    sqlite::Connection store(out / kStore, sqlite::Connection::Mode::write, abilitiesOf(out));
    openResultSchema(store, out / kStore, true);
    MergedCampaign merged;
    merged.notes = notesOn(campaigns);
    for (const Campaign &campaign : campaigns)
        takeKeptFiles(campaign.folder, out);
    {
        sqlite::Transaction transaction(store);
        StoreMerger merger(store, out);
        for (const Campaign &campaign : campaigns)
        {
            if (campaign.folder == out)
                continue;
            const StoreMerger::Counts counts = merger.take(campaign.folder);
            merged.taken += counts.taken;
            merged.twice += counts.twice;
        }
        transaction.commit();
    }
    sqlite::Statement count(store, "SELECT count(*) FROM runs");
    merged.runs = count.step() ? static_cast<std::size_t>(count.integer(0)) : 0;
    writeFile(out / kPlan, campaigns.front().plan);
    writeFile(out / kProvenance, joined(campaigns).toJson());
    store.foldLog();
    return merged;
}

/// A folder that is gone with the object unless it has got its name.
class NewFolder
{
public:
    explicit NewFolder(fs::path name) : name_(std::move(name)), temporary_(name_)
    {
        temporary_ += ".merging";
        std::error_code error;
        if (isThere(temporary_)) // of a merge that was killed; one that is running holds its lock
        {
            const FolderLock lock(temporary_);
            fs::remove_all(temporary_, error);
        }
        fs::create_directories(temporary_, error);
        if (!fs::is_directory(temporary_))
            throw FileError({temporary_.string()}, "cannot be made: " + error.message());
    }
    ~NewFolder()
    {
        std::error_code error;
        fs::remove_all(temporary_, error);
    }
    NewFolder(const NewFolder &) = delete;
    NewFolder &operator=(const NewFolder &) = delete;

    [[nodiscard]] const fs::path &path() const { return temporary_; }

    void commit()
    {
        std::error_code error;
        fs::rename(temporary_, name_, error);
        if (error)
            throw FileError({name_.string()}, "cannot be made: " + error.message());
    }

private:
    fs::path name_;
    fs::path temporary_;
};

} // namespace

MergedCampaign mergeCampaigns(const fs::path &out, std::span<const fs::path> folders)
{
    fs::path target = fs::absolute(out).lexically_normal();
    if (!target.has_filename()) // "results/all/"
        target = target.parent_path();
    const bool isOld = isThere(target / kStore);
    std::error_code error;
    if (!isOld && isThere(target) && !(fs::is_directory(target, error) && fs::is_empty(target, error)))
        throw FileError({out.string()}, "is there already and holds no campaign; name a new folder");

    std::vector<Campaign> campaigns;
    if (isOld)
        campaigns.push_back(campaignIn(target));
    for (const fs::path &folder : folders)
    {
        if (isOld && fs::equivalent(folder, target, error))
            continue;
        campaigns.push_back(campaignIn(folder));
        checkSamePlan(campaigns.front(), campaigns.back());
    }
    if (campaigns.empty())
        throw InputError("there is nothing to merge; name the shards' folders");
    if (isOld)
        return mergeInto(target, campaigns);
    NewFolder made(target);
    MergedCampaign merged = mergeInto(made.path(), campaigns);
    fs::remove(made.path() / ".lock", error);
    made.commit();
    return merged;
}

} // namespace mrpp
