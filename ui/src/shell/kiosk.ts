/** Whether the window is in kiosk mode, where file dialogs, and the print dialog without the PIN, do not open. */
export const isKiosk = () => document.documentElement.dataset.kiosk === "1";
