import type { help as first } from "../pt-BR/help";

/** Examples, help about blocks and keys, and the guided first drive. */
export const help: typeof first = {
  examples: {
    title: "Examples",
    hint: "They open as copies: run them, then take them apart and change them.",
  },
};
