/** The command of PINEL as a person types it on this PC; the server writes it into the page. */
export const command = document.documentElement.dataset.command ?? "pinel";
