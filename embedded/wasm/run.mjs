// Runs the module named on the command line and writes what it prints.
import { readFileSync, writeSync } from "node:fs";

const { instance } = await WebAssembly.instantiate(readFileSync(process.argv[2]), {
  host: {
    print(text, length) {
      writeSync(1, new Uint8Array(instance.exports.memory.buffer, text, length));
    },
  },
});
process.exit(instance.exports.both() === 1 ? 0 : 1);
