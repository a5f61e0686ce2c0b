// SPDX-License-Identifier: BSD-3-Clause
// Reads MAVLink 2 frames with node-mavlink, an implementation that shares nothing with ours: tells
// every field as a line of JSON, and writes the frames anew as it would send them.
// Usage: node node_mavlink.cjs FOLDER_WITH_MODULES FRAMES.bin FIELDS.jsonl AGAIN.bin
const { createRequire } = require('node:module')
const fs = require('node:fs')
const path = require('node:path')

const [folder, input, fieldsFile, againFile] = process.argv.slice(2)
const { createMavLinkStream, MavLinkProtocolV2, minimal, common } = createRequire(
  path.resolve(folder) + '/',
)('node-mavlink')
const kinds = { ...minimal.REGISTRY, ...common.REGISTRY }

// JSON has no 64-bit integers.
const plain = (key, value) => (typeof value === 'bigint' ? value.toString() : value)
const lines = []
const again = []
createMavLinkStream(fs.createReadStream(input))
  .on('data', packet => {
    const kind = kinds[packet.header.msgid]
    const message = packet.protocol.data(packet.payload, kind)
    const fields = {}
    for (const field of kind.FIELDS) fields[field.source] = message[field.name]
    const { seq, sysid, compid } = packet.header
    lines.push(JSON.stringify({ name: kind.MSG_NAME, seq, sysid, compid, fields }, plain))
    again.push(new MavLinkProtocolV2(sysid, compid).serialize(message, seq))
  })
  .on('end', () => {
    fs.writeFileSync(fieldsFile, lines.join('\n') + '\n')
    fs.writeFileSync(againFile, Buffer.concat(again))
  })
