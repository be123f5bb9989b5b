/** What is said of the activity of a lesson. */
export const activity = {
  passed: "Conseguiram! A atividade está resolvida.",
  missing: (what: string) => `Ainda falta para a atividade: ${what}`,
  toTheEnd: "O programa resolve a atividade: agora deixem rodar até o fim.",
  goal: "Desenho do que o robô deve fazer",
  showGoal: "Ver o que o robô deve fazer",
};
