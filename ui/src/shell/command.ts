/** The command of PINEL as a person types it on this PC; the server writes it into the page. */
export const command = document.documentElement.dataset.command ?? "pinel";

/** Code with the command as it works on this PC: "pinel" is on the PATH only where the package is installed. */
export const withCommand = (code: string): string =>
  code.replace(/^pinel (?=[a-z-])/gm, () => `${command} `);
