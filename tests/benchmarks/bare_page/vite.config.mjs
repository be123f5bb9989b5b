import { fileURLToPath } from "node:url";
import { languages } from "../../../ui/languages.ts";

const here = (path) => fileURLToPath(new URL(path, import.meta.url));

export default {
  root: here("."),
  base: "./",
  plugins: [languages()],
  publicDir: here("../../../ui/node_modules/blockly/media"),
  build: { outDir: here("../../../build/bare-page"), emptyOutDir: true, target: "es2022", chunkSizeWarningLimit: 1500 },
};
