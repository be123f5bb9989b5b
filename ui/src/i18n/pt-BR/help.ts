/** Examples, help about blocks and keys, and the guided first drive. */
export const help = {
  examples: {
    title: "Exemplos",
    hint: "Abrem como cópia: rodem, depois desmontem e mudem.",
  },
};
