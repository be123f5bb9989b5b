/** What is said of plots. */
export const ptBR = {
  label: "Gráficos da rodada",
  open: "Gráficos",
  empty: "Apertem Rodar: os gráficos aparecem aqui.",
  larger: "Aumentar o gráfico",
  smaller: "Diminuir o gráfico",
  save: "Salvar gráfico ou tabela",
  picture: "Imagem do gráfico (PNG)",
  table: "Tabela das medidas (CSV)",
  keys: "As setas escolhem o momento.",
  time: "tempo",
  figures: {
    path: "Caminho",
    position: "Posição",
    heading: "Direção",
    speed: "Velocidade",
    turning: "Giro",
  },
  titles: {
    path: "Caminho do robô no chão",
    position: "Posição do robô: x e y ao longo do tempo",
    heading: "Direção do robô ao longo do tempo",
    speed: "Velocidade para a frente: comandada e medida",
    turning: "Velocidade de giro: comandada e medida",
  },
  quantities: { position: "x e y", heading: "direção", speed: "velocidade", turning: "giro" },
  roles: {
    obtained: "obtido",
    desired: "desejado",
    true: "verdadeiro",
    commanded: "comandado",
    measured: "medido",
  },
};

export type PlotsTexts = typeof ptBR;
