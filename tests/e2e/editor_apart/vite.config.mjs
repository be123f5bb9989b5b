import { fileURLToPath } from "node:url";
import { languages } from "../../../ui/languages.ts";

const here = (path) => fileURLToPath(new URL(path, import.meta.url));

export default {
  root: here("."),
  base: "/",
  plugins: [languages()],
  publicDir: false,
  build: { outDir: here("../../../build/editor-apart"), emptyOutDir: true, target: "es2022", chunkSizeWarningLimit: 1500 },
};
