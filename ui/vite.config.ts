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

/**
 * The editor is nearly all of the code, and blocks that are drawn before their font is there are drawn twice: both
 * are fetched beside the page's own code, not after it.
 */
function editorAndFontsEarly(): Plugin {
  return {
    name: "pinel-editor-and-fonts-early",
    apply: "build",
    transformIndexHtml: {
      order: "post",
      handler(_html, { bundle }) {
        const editor = Object.values(bundle ?? {}).find(
          (file) => file.type === "chunk" && file.facadeModuleId?.endsWith("/src/editor/index.ts"),
        );
        const entry = Object.values(bundle ?? {}).find(
          (file) => file.type === "chunk" && file.isEntry,
        );
        if (!editor) throw new Error("the editor is not a chunk of its own");
        if (editor.type === "chunk" && editor.viteMetadata?.importedCss.size) {
          throw new Error("the editor would wait for a style sheet: import it in editor.css");
        }
        const fonts = Object.keys(bundle ?? {}).filter((name) => name.endsWith(".woff2"));
        // what the editor shares with the code that makes blocks of Python is a chunk of its own
        const parts = editor.type === "chunk" ? [editor.fileName, ...editor.imports] : [];
        const early = [
          ...parts
            .filter((name) => name !== entry?.fileName)
            .map((name) => ({ rel: "modulepreload", href: `/${name}`, crossorigin: true })),
          ...fonts.map((name) => ({
            rel: "preload",
            as: "font",
            href: `/${name}`,
            crossorigin: true,
          })),
        ];
        return early.map((attrs) => ({ tag: "link", attrs, injectTo: "head" as const }));
      },
    },
  };
}

export default defineConfig({
  base: "/",
  plugins: [blocklyMedia(), editorAndFontsEarly()],
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
