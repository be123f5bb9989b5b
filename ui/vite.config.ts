import { cpSync } from "node:fs";
import { fileURLToPath } from "node:url";
import type { Plugin } from "vite";
import { defineConfig } from "vitest/config";

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

/** Blockly looks for its cursors and sounds at its maker's host unless they are shipped with the page. */
function blocklyMedia(): Plugin {
  let outDir = "";
  return {
    name: "pinel-blockly-media",
    apply: "build",
    configResolved(config) {
      outDir = config.build.outDir;
    },
    closeBundle() {
      cpSync(here("node_modules/blockly/media"), `${outDir}/media`, { recursive: true });
    },
  };
}

/** The editor is nearly all of the code: it is fetched beside the page's own, not after it. */
function editorEarly(): Plugin {
  return {
    name: "pinel-editor-early",
    apply: "build",
    transformIndexHtml: {
      order: "post",
      handler(_html, { bundle }) {
        const editor = Object.values(bundle ?? {}).find(
          (file) => file.type === "chunk" && file.facadeModuleId?.endsWith("/src/editor/index.ts"),
        );
        if (!editor) throw new Error("the editor is not a chunk of its own");
        const attrs = { rel: "modulepreload", href: `/${editor.fileName}`, crossorigin: true };
        return [{ tag: "link", attrs, injectTo: "head" }];
      },
    },
  };
}

export default defineConfig({
  base: "/",
  plugins: [blocklyMedia(), editorEarly()],
  build: {
    outDir: here("../pinel_desktop/web/static"),
    emptyOutDir: true,
    target: "es2022",
    chunkSizeWarningLimit: 1500,
  },
  server: { fs: { allow: [here("..")] } },
  test: {
    environment: "jsdom",
    include: ["src/**/*.test.ts", "src/**/*.test.tsx", "test/**/*.test.ts"],
  },
});
