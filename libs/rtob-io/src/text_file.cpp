// SPDX-License-Identifier: BSD-3-Clause
#include <rtob/io/text_file.h>

#include <boost/iostreams/filter/bzip2.hpp>
#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_stream.hpp>
#include <filesystem>
#include <locale>

#include "lenient_sink.h"

namespace rtob
{
TextFile::TextFile(const std::string& file) : out_(file)
{
    namespace io = boost::iostreams;
    auto text = std::make_unique<io::filtering_ostream>();
    const auto ending = std::filesystem::path(file).extension();
    if (ending == ".gz")
        text->push(io::gzip_compressor());
    else if (ending == ".bz2")
        text->push(io::bzip2_compressor());
    text->push(LenientSink(out_.stream()));
    text->imbue(std::locale::classic());
    text_ = std::move(text);
}

TextFile::~TextFile() = default;

void TextFile::commit()
{
    text_.reset();  // writes out what the packer still holds
    out_.commit();
}
}  // namespace rtob
