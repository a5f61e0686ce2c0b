// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/core/initializer.h>
#include <mrpt/img/color_maps.h>
#include <mrpt/rtti/CObject.h>
#include <rtob/map/options_io.h>
#include <rtob/map/rtob_map.h>

#include <algorithm>
#include <cctype>

#include "points_map_sections.h"

// The class name only: MRPT registers it with and without its namespace and finds sections and keys
// whatever their case, so this is also "rtobMap". Registered as a second name, that would make each
// map of an .ini twice.
MAP_DEFINITION_REGISTER("rtob::RtobMap", rtob::RtobMap)

namespace rtob
{
namespace
{
mrpt::img::TColormap mrpt_colormap(PointColours colours)
{
    switch (colours)
    {
        case PointColours::One:
            return mrpt::img::cmNONE;
        case PointColours::Grayscale:
            return mrpt::img::cmGRAYSCALE;
        case PointColours::Jet:
            return mrpt::img::cmJET;
        case PointColours::Hot:
            return mrpt::img::cmHOT;
    }
    return mrpt::img::cmNONE;
}

template <class Section>
Section loaded(const mrpt::config::CConfigFileBase& config, const std::string& name)
{
    Section section;
    load_options(config, name, section);
    return section;
}

/// Whatever the case, as MRPT looks for sections.
bool starts_with(const std::string& text, const std::string& start)
{
    return text.size() >= start.size() &&
           std::equal(
               start.begin(), start.end(), text.begin(),
               [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); });
}

/// A section of this map whose name is misspelt would silently leave the defaults.
void refuse_unknown_sections(const mrpt::config::CConfigFileBase& config, const std::string& prefix)
{
    const std::vector<std::string> known{
        prefix + "_creationOpts", prefix + "_insertOpts", prefix + "_likelihoodOpts",
        prefix + "_renderOpts"};
    std::vector<std::string> sections;
    config.getAllSections(sections);
    for (const auto& section : sections)
    {
        if (!starts_with(section, prefix + "_")) continue;
        if (std::any_of(
                known.begin(), known.end(),
                [&](const std::string& name)
                { return name.size() == section.size() && starts_with(section, name); }))
            continue;
        throw std::runtime_error(
            config_name(config) + ": unknown section [" + section + "]" +
            suggestion(section, known));
    }
}
}  // namespace

void register_classes()
{
    mrpt::rtti::registerClass(CLASS_ID(rtob::RtobMap));
}

RtobMap::TMapDefinition::TMapDefinition() = default;

void RtobMap::TMapDefinition::loadFromConfigFile_map_specific(
    const mrpt::config::CConfigFileBase& config, const std::string& prefix)
{
    refuse_unknown_sections(config, prefix);

    const auto creation = loaded<CreationSection>(config, prefix + "_creationOpts");
    creationOpts = creation;
    genericMapParams.enableSaveAs3DObject = creation.enableSaveAs3DObject;
    genericMapParams.enableObservationLikelihood = creation.enableObservationLikelihood;
    genericMapParams.enableObservationInsertion = creation.enableObservationInsertion;

    const auto insertion = loaded<InsertionSection>(config, prefix + "_insertOpts");
    insertionOpts = insertion;
    insertionOpts.horizontalTolerance = mrpt::DEG2RAD(insertion.horizontal_tolerance_deg);

    likelihoodOpts = loaded<LikelihoodSection>(config, prefix + "_likelihoodOpts");

    const auto render = loaded<RenderSection>(config, prefix + "_renderOpts");
    renderOpts = render;
    renderOpts.colormap = mrpt_colormap(render.colours);
}

void RtobMap::TMapDefinition::dumpToTextStream_map_specific(std::ostream& out) const
{
    save_options(out, "creationOpts", creationOpts);
    insertionOpts.dumpToTextStream(out);
    likelihoodOpts.dumpToTextStream(out);
    renderOpts.dumpToTextStream(out);
}

namespace
{
template <class Pointer>
Pointer created(const mrpt::maps::TMetricMapInitializer& initializer)
{
    const auto& definition = dynamic_cast<const RtobMap::TMapDefinition&>(initializer);
    auto* map = new RtobMap(definition.creationOpts);
    Pointer owner(map);
    map->insertionOptions = definition.insertionOpts;
    map->likelihoodOptions = definition.likelihoodOpts;
    map->renderOptions = definition.renderOpts;
    return owner;
}
}  // namespace

// MRPT 2.11.3 made the registry return shared pointers; MRPT_VERSION is 0x258 for 2.5.8.
#if MRPT_VERSION >= 0x020B03
mrpt::maps::CMetricMap::Ptr RtobMap::internal_CreateFromMapDefinition(
    const mrpt::maps::TMetricMapInitializer& definition)
{
    return created<mrpt::maps::CMetricMap::Ptr>(definition);
}
#else
mrpt::maps::CMetricMap* RtobMap::internal_CreateFromMapDefinition(
    const mrpt::maps::TMetricMapInitializer& definition)
{
    return created<mrpt::maps::CMetricMap*>(definition);
}
#endif
}  // namespace rtob

MRPT_INITIALIZER(register_rtob_map_classes)
{
    rtob::register_classes();
}
