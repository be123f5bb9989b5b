import type { help as first } from "../pt-BR/help";

/** Examples, help about blocks and keys, and the guided first drive. */
export const help: typeof first = {
  examples: {
    title: "Ejemplos",
    hint: "Se abren como copia: ejecútenlos, luego desármenlos y cámbienlos.",
  },
};
