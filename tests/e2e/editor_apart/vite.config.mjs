import { fileURLToPath } from "node:url";

const here = (path) => fileURLToPath(new URL(path, import.meta.url));

export default {
  root: here("."),
  base: "/",
  publicDir: false,
  build: { outDir: here("../../../build/editor-apart"), emptyOutDir: true, target: "es2022", chunkSizeWarningLimit: 1500 },
};
