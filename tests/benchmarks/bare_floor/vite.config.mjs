import { fileURLToPath } from "node:url";
import { languages } from "../../../ui/languages.ts";

const here = (path) => fileURLToPath(new URL(path, import.meta.url));

export default {
  root: here("."),
  base: "./",
  plugins: [languages()],
  resolve: { alias: { three: here("../../../ui/node_modules/three") } },
  build: { outDir: here("../../../build/bare-floor"), emptyOutDir: true, target: "es2022", chunkSizeWarningLimit: 1500 },
};
