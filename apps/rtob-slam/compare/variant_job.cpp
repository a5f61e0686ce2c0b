// SPDX-License-Identifier: BSD-3-Clause
#include "compare/variant_job.h"

#include <rtob/core/enum_names.h>
#include <rtob/io/atomic_file.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace rtob
{
namespace
{
using Json = nlohmann::ordered_json;
}  // namespace

void write_job(const std::string& file, const VariantJob& job)
{
    Json json;
    json["log"] = job.log;
    json["folder"] = job.folder;
    json["config_file"] = job.config_file;
    json["sets"] = job.sets;
    json["skip_scans"] = job.limits.skip_scans;
    json["first_scans"] = job.limits.first_scans;
    json["use_odometry"] = job.limits.use_odometry;
    json["kind"] = std::string(name_of(job.kind));
    json["density"] = job.density;
    json["variant_file"] = job.variant_file;
    json["seed"] = job.seed;
    json["time_limit_s"] = job.time_limit_s;
    json["title"] = job.title;
    write_text(file, json.dump(2) + "\n");
}

VariantJob read_job(const std::string& file)
{
    std::ifstream in(file);
    if (!in) throw std::runtime_error(file + " cannot be read");
    VariantJob job;
    try
    {
        const Json json = Json::parse(in);
        json.at("log").get_to(job.log);
        json.at("folder").get_to(job.folder);
        json.at("config_file").get_to(job.config_file);
        json.at("sets").get_to(job.sets);
        json.at("skip_scans").get_to(job.limits.skip_scans);
        json.at("first_scans").get_to(job.limits.first_scans);
        json.at("use_odometry").get_to(job.limits.use_odometry);
        job.kind = parse_enum<VariantKind>(json.at("kind").get<std::string>());
        json.at("density").get_to(job.density);
        json.at("variant_file").get_to(job.variant_file);
        json.at("seed").get_to(job.seed);
        json.at("time_limit_s").get_to(job.time_limit_s);
        json.at("title").get_to(job.title);
    }
    catch (const std::exception& error)
    {
        throw std::runtime_error(file + " is no job of rtob-slam compare: " + error.what());
    }
    return job;
}

RunConfig config_of(const VariantJob& job)
{
    auto flags = parse_set_flags(job.sets);
    flags.push_back({"--seed", "Run", "seed", std::to_string(job.seed)});
    if (!job.density.empty()) flags.push_back({"--density", "Density", "density", job.density});
    return load_run_config(job.config_file, flags);
}
}  // namespace rtob
